namespace Nowpose.Kinematics
{
    enum VisualShape
    {
        Box,

        /// <summary>About its own z axis, its middle at the origin.</summary>
        Cylinder,
        Sphere,
        Mesh,
    }
}
