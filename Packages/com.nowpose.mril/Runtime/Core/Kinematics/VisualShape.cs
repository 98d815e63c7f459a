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
}
