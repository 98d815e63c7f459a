namespace Nowpose.Kinematics
{
    /// <summary>One visual shape of a link.</summary>
    sealed class LinkVisual
    {
        internal LinkVisual(
            VisualShape shape, in RigidTransform origin, (double X, double Y, double Z) size, string meshFile, VisualColour? colour)
        {
            Shape = shape;
            Origin = origin;
            Size = size;
            MeshFile = meshFile;
            Colour = colour;
        }

        public VisualShape Shape { get; }

        /// <summary>The shape's frame in the link's.</summary>
        public RigidTransform Origin { get; }

        /// <summary>Full extent along the shape's own axes in metres (diameters, not radii); for a mesh its scale, without unit.</summary>
        public (double X, double Y, double Z) Size { get; }

        /// <summary>Name in the URDF (<c>package://…</c> or a path); null unless <see cref="VisualShape.Mesh"/>.</summary>
        public string MeshFile { get; }

        /// <summary>Null if the URDF specifies none.</summary>
        public VisualColour? Colour { get; }
    }
}
