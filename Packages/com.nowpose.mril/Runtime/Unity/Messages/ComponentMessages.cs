namespace Nowpose.Unity.Messages
{
    /// <summary>Error messages for Unity's console about the settings of components. Most messages state a remedy.</summary>
    static class ComponentMessages
    {
        public static string Of(string kind, string component, string problem) => $"{kind} '{component}': {problem}";

        public static string NoAction(string component, string kind) => $"cell actions '{component}' have no {kind}; assign one";

        public static string NoCalibration(string component) => $"cell actions '{component}': no Latency Nudge is at the session or below it; add one";

        public static string NoFontMaterial(string component) =>
            $"font texture '{component}' has no font material, so its letters are blocks; assign the material that is a sub-asset of the font";

        public static string GhostWithoutRig(string component) => $"ghost '{component}' has no displayed rig for the comparison; assign one";
        public static string GripWithoutRig(string component) => $"grip by reach '{component}' has no rig on a parent; assign one";

        public static string MarkerBelowBase(string component) =>
            $"hand placed marker '{component}' is below a base anchor and would move with it; move it to another parent below the session";

        public static string NudgeWithoutRig(string component) => $"latency nudge '{component}' has no rig below the session; assign one";

        public const string NoMaterial = "has no material; assign one";

        public static string Vertices(int vertices, int max) => $"has a load of {vertices} vertices; allowed: 0 to {max}";

        public const string NoSession = "has no session on its object or a parent; assign one";

        public const string SourceOutsideSession =
            "no session is on this object or a parent, so no base anchor uses the markers; move the component to the session's object";

        public const string SweepDisabled = "is switched off or has not started yet; enable it and its object, and start the sweep again";
        public const string PairingDisabled = "is switched off or has not started yet, so the call has no effect; enable it and its object first";
        public const string NoLoadGenerator = "has no load generator on its object or a child; assign one";
        public const string NoRenderTimeSource = "has no render time source at its session; assign one";

        public static string NoSettings(string component) => $"session '{component}' has no settings; assign a Session Settings asset";

        public static string NoLineMaterial(string component) =>
            $"planned path '{component}' has no material, so its line is magenta; assign one in its Line Renderer";

        public static string PathWithoutRig(string component) => $"planned path '{component}' has no rig on a parent; assign one";

        public static string RigWithoutSession(string component) =>
            $"rig '{component}' has no session on its object or a parent; assign one, or call Bind and Apply";

        public static string ComponentWithoutSession(string kind, string component) =>
            $"{kind} '{component}' has no session on its object or a parent; assign one";

        public static string PanelWithoutText(string component) =>
            $"status panel '{component}' has no Text Mesh to copy; assign one on a child object";

        public static string DisplayWithoutMaterial(string component) =>
            $"timestamp display '{component}' has no material for its squares; assign one";

        public static string GripperWithoutRig(string component) => $"gripper '{component}' has no rig; move it below a rig, or assign a rig";

        public static string GripperWithoutLink(string component, string robot, string link) =>
            $"gripper '{component}': robot '{robot}' has no link '{link}'; correct Flange Link";

        public static string GripperWithoutJoint(string component, string robot, string joints) =>
            $"gripper '{component}': robot '{robot}' has no moving joint {joints}, so its finger does not move";

        /// <param name="joints">Quoted names that are not names of moving joints.</param>
        public static string FingerJointUnknown(string robot, string joints) =>
            $"robot '{robot}' has no moving joint {joints}; correct Joint of the gripper's finger";
    }
}
