#pragma once

#include "common/fem/elastic_body.hpp"
#include "common/fem/surface_embedding.hpp"
#include "common/simulation/contact_coordinates.hpp"
#include "common/simulation/mass_parts.hpp"

#include <array>
#include <vector>

namespace enduring {

/// What impulses at surface vertices do to the velocities there, for a body whose elements pass them on
/// within the step: the blocks S_u A^-1 S_v^T of its system's inverse.
///
/// A vertex costs three passes through the factor, so it is computed when first asked for. Its blocks are
/// kept in the frames of the elements around both vertices and turn with them; that the elements also deform
/// changes them little. In which order the vertices of one step are asked for changes no bit.
class VertexResponse {
public:
    /// Both outlive it.
    VertexResponse(const ElasticBody& body, const SurfaceEmbedding& embedding)
        : body_(body), embedding_(embedding)
    {}

    /// A new step has begun: the elements have turned, and where dt [s]
    /// is another one the system is another, too.
    void begin_step(double dt);
    /// What was learned belongs to another system: nodes were fixed or freed.
    void forget();
    /// Computes all that block() may be asked for among these, in one passage through the factor.
    void learn(std::span<const int> vertices);
    /// Velocity change at vertex u per impulse at vertex v [1/kg]; block(v, u) is its transpose.
    Mat3 block(int u, int v);

    /// Sum of weight times length of block(vertex, .) over the pushes [1/kg]. As a matrix of blocks has no
    /// eigenvalue above its largest such sum, this bounds what they do together.
    double response_bound(int vertex, std::span<const Push> pushes);

    /// The blocks of these vertices as one matrix [1/kg], and its inverse. Learned in other positions of the
    /// elements, they need not belong to a positive matrix: a part of their diagonal on top makes it one.
    /// Where the elements have turned far against each other, all is computed anew.
    ContactMass mass_of(std::span<const int> vertices);

private:
    friend class ResponseTrial;

    /// Velocities of all nodes for a unit impulse along each axis [1/kg].
    using UnitResponses = std::array<NodalVectors, 3>;
    struct Block {
        Mat3 matrix;
        double length;  ///< Frobenius
    };
    struct Vertex {
        int vertex;
        std::vector<int> elements;  ///< around its first node
        UnitResponses responses;    ///< kept for the step in which it was computed
        /// of this vertex with each one computed before and itself, in the frames of both
        std::vector<Block> blocks;
        Mat3 frame = Mat3::Identity(), first_frame = Mat3::Identity();  ///< now; when it was computed
        int frame_of_step = -1;
    };
    bool has_bent(std::span<const int> vertices);
    int column_of(int vertex);
    const Block& stored(int i, int j) const;
    std::array<NodalVectors, 3> unit_impulses(int vertex) const;
    void append_column(int vertex, UnitResponses responses);
    Mat3 block_to(const UnitResponses& responses, int vertex) const;
    const Mat3& frame(Vertex& vertex);
    ContactMass local_mass_of(std::span<const int> vertices);

    const ElasticBody& body_;
    const SurfaceEmbedding& embedding_;
    double dt_ = 0;
    int step_ = 0;
    std::vector<int> place_;  ///< of each surface vertex among those computed, -1 before
    std::vector<Vertex> vertices_;
    std::vector<int> new_;      ///< places of those computed in this step
    std::vector<int> massive_;  ///< vertices that were asked for their mass
    ContactMass local_;         ///< theirs, in their frames, where it is the same in every step
};

/// Impulses at surface vertices that are tried out, and what all of them change at a vertex.
class ResponseTrial {
public:
    /// The response outlives it, and stays in the same step.
    explicit ResponseTrial(VertexResponse& response) : response_(response) {}

    /// [N s]
    void push(int vertex, const Vec3& impulse);
    /// By all impulses so far [m/s].
    Vec3 change(int vertex);

private:
    struct OfVertex {
        bool is_pushed = false;
        Vec3 impulse = Vec3::Zero();  ///< in the vertex' frame
        Vec3 change = Vec3::Zero();   ///< in world axes
        long change_of = -1;          ///< number of pushes that `change` is for
    };
    OfVertex& at_place(int place);

    VertexResponse& response_;
    std::vector<OfVertex> vertices_;  ///< by their places in the response
    std::vector<int> pushed_;         ///< places of those that are pushed, in their order
    long pushes_ = 0;
};

}  // namespace enduring
