namespace Nowpose.Kinematics
{
    enum VisualShape
    {
        Box,

        /// <summary>A cylinder about its own z axis with its centre at the origin.</summary>
        Cylinder,
        Sphere,
        Mesh,
    }

    /// <summary>One visual shape of a link.</summary>
    sealed class LinkVisual
    {
        internal LinkVisual(
            VisualShape shape, in RigidTransform origin, (double X, double Y, double Z) size, string meshFile, VisualColour? colour) =>
            (Shape, Origin, Size, MeshFile, Colour) = (shape, origin, size, meshFile, colour);

        public VisualShape Shape { get; }

        /// <summary>Pose of the shape's frame in the frame of the link.</summary>
        public RigidTransform Origin { get; }

        /// <summary>Full extent along the shape's own axes in metres (diameters, not radii); for a mesh, the dimensionless scale.</summary>
        public (double X, double Y, double Z) Size { get; }

        /// <summary>
        /// Mesh file as named in the URDF (<c>package://NAME/PATH</c> or a path); null for shapes other than <see cref="VisualShape.Mesh"/>.
        /// </summary>
        public string MeshFile { get; }

        /// <summary>Colour of the shape; null if the URDF specifies none.</summary>
        public VisualColour? Colour { get; }
    }

    /// <summary>Red, green, blue and opacity, as written in the URDF. The valid range is 0 to 1, which is not enforced.</summary>
    readonly struct VisualColour
    {
        public VisualColour(double red, double green, double blue, double alpha) => (Red, Green, Blue, Alpha) = (red, green, blue, alpha);

        public double Red { get; }
        public double Green { get; }
        public double Blue { get; }
        public double Alpha { get; }
    }
}
