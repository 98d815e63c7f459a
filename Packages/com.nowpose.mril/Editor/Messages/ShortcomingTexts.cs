namespace Nowpose.Editor.Messages
{
    /// <summary>Messages about missing references and components, each with a remedy.</summary>
    static class ShortcomingTexts
    {
        public const string Settings = "It has no settings and cannot start. Assign settings, or let a script provide them.";
        public const string RigSession = "This object and its parents have no session. Assign one, or let a script bind and move the rig.";
        public const string ReportSession = "This object and its parents have no session. Assign the session that receives the render time.";
        public const string CalibratedSession = "This object and its parents have no session. Assign the session to calibrate.";
        public const string PairedSession = "This object and its parents have no session. Assign the session to set up.";
        public const string ShownSession = "This object and its parents have no session. Assign the session whose pose is shown.";

        public const string ObjectSession = "This object and its parents have no session. Assign the session that receives the object's frame.";
        public const string SignalSession = "This object and its parents have no session. Assign the session that receives the signal.";
        public const string RecordedSession = "This object and its parents have no session. Assign the session to record.";
        public const string FramesSession = "This object and its parents have no session. Assign the session whose frames are used.";
        public const string ActionsSession = "This object and its parents have no session. Assign the session of the cell.";
        public const string Load = "This object and its children have no load generator. Assign one.";
        public const string Light = "It has no material for the lit squares. Assign a bright, unlit one.";

        public const string Substitute =
            "Some parts have materials that cannot fade, because their shaders lack _Hatch or _Fade. They are hidden while the pose is not "
            + "current. Assign a substitute, or add NowposePose.hlsl to their shaders.";

        public const string StatusSession = "This object and its parents have no session. Assign the session whose status is shown.";

        public const string PanelText =
            "It has no Text Mesh to copy. Assign one on a child object; its font, material, style and colour apply to the whole panel.";

        public const string Appearance =
            "This object and its parents have no Pose Appearance, so the robot looks the same while its pose is not current. Add one.";

        public const string SignalAppearance =
            "This object and its parents have no Pose Appearance, so the parts look the same while the signal is not current. Add one.";

        /// <param name="rig">Name of the other rig.</param>
        public static string SameRobot(string rig) => $"'{rig}' displays the same robot. If this is another robot, enter its Robot Namespace.";

        /// <param name="other">Name of the other object.</param>
        public static string SameFrame(string other, string frame) =>
            $"'{other}' has the same frame '{frame}', so each replaces the saved place of the other. Enter another Frame.";

        public const string MovedByObject =
            "The tracked or stationary object on the same object moves it. Move the Actuated Part to a child object.";

        /// <param name="rig">Name of the rig that moves the object.</param>
        public static string MovedByJoint(string rig, string joint) =>
            $"Joint '{joint}' of '{rig}' moves the same object. Move the Actuated Part to a child object.";

        /// <param name="gripper">Name of the gripper that moves the object.</param>
        public static string MovedByGripper(string gripper, string joint) =>
            $"'{gripper}' moves the same object with joint '{joint}'. Move the Actuated Part to a child object, or remove the finger from the gripper.";

        /// <param name="switched">Name of the object that the event switches.</param>
        public static string SwitchesItself(string switched) =>
            $"An event switches '{switched}', which is this object or a parent. While it is off, the signal raises no events, so it cannot switch it "
            + "on again. Let the event switch another object, such as a child.";

        public const string RigBesideBase =
            "It is not below the Base Anchor of its session, so it does not follow the base, unless the cell has a frame of its root link. Move it "
            + "below the Base Anchor.";

        public const string ScaledBase =
            "Its scale in the scene is not 1, so the displayed robot has another size than the real robot, at which the markers place it. Set the "
            + "scale of this object and of its parents to 1.";

        public const string Rig = "Its parents have no rig. Move the object below a rig, or assign a rig.";
    }
}
