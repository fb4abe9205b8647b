#include "common/simulation/vertex_response.hpp"

#include "common/fem/polar_rotation.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace enduring {
namespace {

std::vector<int> elements_at(const ElasticMesh& mesh, int node)
{
    std::vector<int> found;
    for (std::size_t e = 0; e < mesh.elements().size(); ++e) {
        const auto begin = mesh.elements()[e].nodes.begin(), end = begin + nodes_of(mesh.basis());
        if (std::find(begin, end, node) != end)
            found.push_back(static_cast<int>(e));
    }
    return found;
}

//! [softened]
/// Ten times the part of the diagonal that makes it positive keeps it off the border. What nothing moves,
/// since its nodes are fixed, gets a mass a million times as large as the least that there is.
/// @param response  its lower half
ContactMass softened(Eigen::MatrixXd response)
{
    constexpr double held = 1e-6;
    const double largest = response.diagonal().maxCoeff();
    for (double& own : response.diagonal())
        if (own <= 0)
            own = held * (largest > 0 ? largest : 1);
    const auto with = [&](double part) {
        Eigen::MatrixXd matrix = response;
        matrix.diagonal() *= 1 + part;
        return matrix;
    };
    double part = 1e-5;
    while (with(part).llt().info() != Eigen::Success && part < 1)
        part *= 10;
    response = with(10 * part).selfadjointView<Eigen::Lower>();
    return {response.llt().solve(Eigen::MatrixXd::Identity(response.rows(), response.cols())), response};
}
//! [softened]

}  // namespace

void VertexResponse::begin_step(double dt)
{
    ++step_;
    for (const int place : new_)
        vertices_[place].responses = {};
    new_.clear();
    if (dt != dt_)
        forget();
    dt_ = dt;
}

void VertexResponse::forget()
{
    vertices_.clear();
    new_.clear();
    place_.assign(static_cast<std::size_t>(embedding_.vertex_count()), -1);
    massive_.clear();
}

const Mat3& VertexResponse::frame(Vertex& vertex)
{
    if (vertex.frame_of_step != step_) {
        Mat3 sum = Mat3::Zero();
        for (const int e : vertex.elements)
            sum += body_.rotations()[e];
        vertex.frame = polar_rotation(sum);
        vertex.frame_of_step = step_;
    }
    return vertex.frame;
}

/// On the nodes, for an impulse along each axis.
std::array<NodalVectors, 3> VertexResponse::unit_impulses(int vertex) const
{
    std::array<NodalVectors, 3> impulses;
    for (int axis = 0; axis < 3; ++axis) {
        impulses[axis] = NodalVectors::Zero(3, body_.node_count());
        for (const auto& [node, weight] : embedding_.nodes_of(vertex))
            impulses[axis](axis, node) = weight;
    }
    return impulses;
}

Mat3 VertexResponse::block_to(const UnitResponses& responses, int vertex) const
{
    Mat3 block;
    for (int axis = 0; axis < 3; ++axis)
        block.col(axis) = embedding_.at(vertex, responses[axis]);
    return block;
}

//! [column_of]
int VertexResponse::column_of(int vertex)
{
    if (place_.empty())
        place_.assign(static_cast<std::size_t>(embedding_.vertex_count()), -1);
    if (place_[vertex] < 0) {
        const auto impulses = unit_impulses(vertex);
        append_column(vertex, {body_.near_response(impulses[0]), body_.near_response(impulses[1]),
                               body_.near_response(impulses[2])});
    }
    return place_[vertex];
}

void VertexResponse::append_column(int vertex, UnitResponses responses)
{
    place_[vertex] = static_cast<int>(vertices_.size());
    new_.push_back(place_[vertex]);
    vertices_.push_back({vertex,
                         elements_at(body_.mesh(), embedding_.nodes_of(vertex).front().node),
                         std::move(responses),
                         {}});
    Vertex& own = vertices_.back();
    const Mat3 own_frame = frame(own);
    own.first_frame = own_frame;
    for (Vertex& other : vertices_) {
        // Both responses tell the same block up to rounding; the lower vertex's does where there is a choice.
        const bool others = other.responses[0].size() > 0 && other.vertex < vertex;
        const Mat3 block = others ? block_to(other.responses, vertex)
                                  : Mat3(block_to(own.responses, other.vertex).transpose());
        const Mat3 local = own_frame.transpose() * block * frame(other);
        own.blocks.push_back(
            {&other == &own ? Mat3(0.5 * (local + local.transpose())) : local, local.norm()});
    }
}
//! [column_of]

void VertexResponse::learn(std::span<const int> vertices)
{
    if (place_.empty())
        place_.assign(static_cast<std::size_t>(embedding_.vertex_count()), -1);
    std::vector<int> unknown;
    std::vector<NodalVectors> fields;
    for (const int vertex : vertices)
        if (place_[vertex] < 0) {
            unknown.push_back(vertex);
            for (NodalVectors& impulse : unit_impulses(vertex))
                fields.push_back(std::move(impulse));
        }
    body_.near_responses(fields);
    for (std::size_t i = 0; i < unknown.size(); ++i)
        append_column(unknown[i],
                      {std::move(fields[3 * i]), std::move(fields[3 * i + 1]), std::move(fields[3 * i + 2])});
}

const VertexResponse::Block& VertexResponse::stored(int i, int j) const
{
    return vertices_[std::max(i, j)].blocks[std::min(i, j)];
}

Mat3 VertexResponse::block(int u, int v)
{
    const int i = column_of(u), j = column_of(v);
    const Mat3& local = stored(i, j).matrix;
    const Mat3 turned = i >= j ? local : Mat3(local.transpose());
    return frame(vertices_[i]) * turned * frame(vertices_[j]).transpose();
}

double VertexResponse::response_bound(int vertex, std::span<const Push> pushes)
{
    const int place = column_of(vertex);
    double sum = 0;
    for (const Push& push : pushes)
        sum += push.weight * stored(place, column_of(push.vertex)).length;
    return sum;
}

ResponseTrial::OfVertex& ResponseTrial::at_place(int place)
{
    if (static_cast<std::size_t>(place) >= vertices_.size())
        vertices_.resize(response_.vertices_.size());
    return vertices_[place];
}

void ResponseTrial::push(int vertex, const Vec3& impulse)
{
    const int place = response_.column_of(vertex);
    OfVertex& own = at_place(place);
    if (!own.is_pushed)
        pushed_.push_back(place);
    own.is_pushed = true;
    own.impulse += response_.frame(response_.vertices_[place]).transpose() * impulse;
    ++pushes_;
}

Vec3 ResponseTrial::change(int vertex)
{
    const int place = response_.column_of(vertex);
    OfVertex& own = at_place(place);
    if (own.change_of == pushes_)
        return own.change;  // several pairs ask for the same vertex
    Vec3 local = Vec3::Zero();
    for (const int other : pushed_) {
        const Mat3& block = response_.stored(place, other).matrix;
        const Vec3& impulse = vertices_[other].impulse;
        if (place >= other)
            local.noalias() += block * impulse;
        else
            local.noalias() += block.transpose() * impulse;
    }
    own.change = response_.frame(response_.vertices_[place]) * local;
    own.change_of = pushes_;
    return own.change;
}

ContactMass VertexResponse::local_mass_of(std::span<const int> vertices)
{
    learn(vertices);
    const auto size = static_cast<Eigen::Index>(3 * vertices.size());
    Eigen::MatrixXd response(size, size);
    for (std::size_t u = 0; u < vertices.size(); ++u)
        for (std::size_t v = 0; v <= u; ++v) {
            const int i = column_of(vertices[u]), j = column_of(vertices[v]);
            const Mat3& local = stored(i, j).matrix;
            // the lower half is all that the factorisation looks at
            response.block<3, 3>(static_cast<Eigen::Index>(3 * u),
                                 static_cast<Eigen::Index>(3 * v)) = i >= j ? local : Mat3(local.transpose());
        }
    return softened(std::move(response));
}

//! [has_bent]
/// Whether the elements around these vertices have turned against each other since their responses were
/// computed, by more than a mean turn of all of them explains.
bool VertexResponse::has_bent(std::span<const int> vertices)
{
    constexpr double largest_turn = 0.07;  // [rad], see chapter 7
    std::vector<Vertex*> known;
    Mat3 sum = Mat3::Zero();
    for (const int vertex : vertices)
        if (!place_.empty() && place_[vertex] >= 0) {
            known.push_back(&vertices_[place_[vertex]]);
            sum += frame(*known.back()) * known.back()->first_frame.transpose();
        }
    const Mat3 turn = polar_rotation(sum);
    return std::any_of(known.begin(), known.end(), [&](Vertex* vertex) {
        // a turn by a small angle is this length away from none
        return (frame(*vertex) - turn * vertex->first_frame).norm() > std::sqrt(2.0) * largest_turn;
    });
}
//! [has_bent]

namespace {

/// A matrix of blocks with each block's two sides in world axes.
Eigen::MatrixXd turned(const Eigen::MatrixXd& local, const std::vector<Mat3>& frames)
{
    Eigen::MatrixXd world(local.rows(), local.cols());
    for (Eigen::Index u = 0; u < local.rows() / 3; ++u)
        for (Eigen::Index v = 0; v < local.cols() / 3; ++v)
            world.block<3, 3>(3 * u, 3 * v) = frames[static_cast<std::size_t>(u)] *
                                              local.block<3, 3>(3 * u, 3 * v) *
                                              frames[static_cast<std::size_t>(v)].transpose();
    return world;
}

}  // namespace

//! [mass_of]
ContactMass VertexResponse::mass_of(std::span<const int> vertices)
{
    if (has_bent(vertices))
        forget();
    if (!std::equal(vertices.begin(), vertices.end(), massive_.begin(), massive_.end())) {
        local_ = local_mass_of(vertices);
        massive_.assign(vertices.begin(), vertices.end());
    }
    std::vector<Mat3> frames;
    for (const int vertex : vertices)
        frames.push_back(frame(vertices_[column_of(vertex)]));
    return {turned(local_.mass, frames), turned(local_.response, frames)};
}
//! [mass_of]

}  // namespace enduring
