namespace Nowpose.Kinematics
{
    /// <summary>Red, green, blue and opacity, as written in the URDF; the valid range is 0…1, which is not enforced.</summary>
    readonly struct VisualColour
    {
        public VisualColour(double red, double green, double blue, double alpha)
        {
            Red = red;
            Green = green;
            Blue = blue;
            Alpha = alpha;
        }

        public double Red { get; }
        public double Green { get; }
        public double Blue { get; }
        public double Alpha { get; }
    }
}
