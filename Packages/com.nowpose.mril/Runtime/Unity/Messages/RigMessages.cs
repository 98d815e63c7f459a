namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages about rigs and the objects below them.</summary>
    static class RigMessages
    {
        public static string NoDescription(string robot, string rig) =>
            $"robot namespace '{robot}': it has no robot description; assign a Robot Description to the rig '{rig}'";

        /// <param name="rig">Name of the other rig.</param>
        public static string SameRobot(string rig) => $"same robot as the rig '{rig}'; enter the Robot Namespace of the other robot";

        public static string NoRootLink(string robot, string rig, string root, string drawn) =>
            $"robot '{robot}': no object below '{rig}' has the name of its root link '{root}', but '{drawn}' is drawn there; name an object "
            + $"after each link of the URDF, or remove '{drawn}' so that the rig builds the robot";

        /// <param name="parent">The parent link, or the rig if the link is the root.</param>
        public static string MovedBetween(string robot, string between, string parent, string link) =>
            $"robot '{robot}': '{between}' is between '{parent}' and the link '{link}' and is moved, turned or scaled; reset its transform";

        public static string ScaledLink(string robot, string link) =>
            $"robot '{robot}': link '{link}' is scaled, and so are its children; scale the visible object instead";

        public static string MissingLink(string robot, string parent, string rig, string link, string joint, string where) =>
            $"robot '{robot}': below link '{parent}' in '{rig}', link '{link}' of joint '{joint}' {where}; name an object after each link of the "
            + "URDF and nest the objects in the same way";

        public static string NoUrdf(string asset) => $"'{asset}': contains no URDF; load the URDF of the robot";
        public static string NotBound(string rig) => $"rig '{rig}': bind it to a robot before joints are applied";

        public static string FixedJoint(string joint) => $"joint '{joint}' is fixed; pass a moving joint";

        public static string ValueCount(string rig, int values, int joints) =>
            $"rig '{rig}': {values} values for {joints} moving joints; pass one value for each moving joint";

        /// <param name="hasShader">Whether the build contains the shader that is used in place of the missing material.</param>
        public static string NoMaterial(string rig, bool hasShader) => hasShader
            ? $"rig '{rig}' has no material for the robot that it built, so the robot is drawn by the shader Nowpose/Hologram; "
                + "assign Arm Material and Tool Material"
            : $"rig '{rig}' has no material for the robot that it built, so the robot is magenta, because this build does not contain the shader "
                + "Nowpose/Hologram; assign Arm Material and Tool Material";
    }
}
