#include "common/simulation/vertex_response.hpp"

#include "common/fem/polar_rotation.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

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

//! [softened_inverse]
/// Ten times the part of the diagonal that makes it positive keeps it off the border. What nothing moves, since
/// its nodes are fixed, gets a mass a million times as large as the least that there is.
Eigen::MatrixXd softened_inverse(Eigen::MatrixXd response)
{
    constexpr double held = 1e-6;
    const double largest = response.diagonal().maxCoeff();
    for (double& own : response.diagonal())
        if (own <= 0)
            own = held * (largest > 0 ? largest : 1);
    const auto softened = [&](double part) {
        Eigen::MatrixXd matrix = response;
        matrix.diagonal() *= 1 + part;
        return matrix;
    };
    double part = 1e-5;
    while (softened(part).llt().info() != Eigen::Success && part < 1)
        part *= 10;
    return softened(10 * part).llt().solve(Eigen::MatrixXd::Identity(response.rows(), response.cols()));
}
//! [softened_inverse]

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

VertexResponse::UnitResponses VertexResponse::unit_responses(int vertex) const
{
    UnitResponses responses;
    for (int axis = 0; axis < 3; ++axis) {
        NodalVectors impulse = NodalVectors::Zero(3, body_.node_count());
        for (const auto& [node, weight] : embedding_.nodes_of(vertex))
            impulse(axis, node) = weight;
        responses[axis] = body_.near_response(impulse);
    }
    return responses;
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
    int& place = place_[vertex];
    if (place >= 0)
        return place;
    place = static_cast<int>(vertices_.size());
    new_.push_back(place);
    vertices_.push_back({vertex,
                         elements_at(body_.mesh(), embedding_.nodes_of(vertex).front().node),
                         unit_responses(vertex),
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
    return place;
}
//! [column_of]

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

Eigen::MatrixXd VertexResponse::local_mass_of(std::span<const int> vertices)
{
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
    return softened_inverse(response);
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

//! [mass_of]
Eigen::MatrixXd VertexResponse::mass_of(std::span<const int> vertices)
{
    if (has_bent(vertices))
        forget();
    if (!std::equal(vertices.begin(), vertices.end(), massive_.begin(), massive_.end())) {
        local_mass_ = local_mass_of(vertices);
        massive_.assign(vertices.begin(), vertices.end());
    }
    Eigen::MatrixXd mass(local_mass_.rows(), local_mass_.cols());
    std::vector<Mat3> frames;
    for (const int vertex : vertices)
        frames.push_back(frame(vertices_[column_of(vertex)]));
    for (std::size_t u = 0; u < vertices.size(); ++u)
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            const auto row = static_cast<Eigen::Index>(3 * u), column = static_cast<Eigen::Index>(3 * v);
            mass.block<3, 3>(row, column) = frames[u] * local_mass_.block<3, 3>(row, column) *
                                            frames[v].transpose();
        }
    return mass;
}
//! [mass_of]

}  // namespace enduring
