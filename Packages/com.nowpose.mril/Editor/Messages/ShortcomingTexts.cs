namespace Nowpose.Editor.Messages
{
    /// <summary>Missing references of components, with remedies.</summary>
    static class ShortcomingTexts
    {
        public const string Settings = "It has no settings and cannot start. Assign settings, or let a script provide them.";
        public const string RigSession = "There is no session on this object or a parent. Assign one, or let a script bind and move the rig.";
        public const string ReportSession = "There is no session on this object or a parent for the report. Assign one.";
        public const string CalibratedSession = "There is no session on this object or a parent. Assign the session to calibrate.";
        public const string PairedSession = "There is no session on this object or a parent. Assign the session to set up.";
        public const string ShownSession = "There is no session on this object or a parent. Assign the session whose pose is shown.";

        public const string Substitute =
            "Some parts have materials that cannot fade, because their shaders lack _Hatch or _Fade. They are hidden while the pose is not "
            + "current. Assign a substitute, or add NowposePose.hlsl to their shaders.";

        public const string StatusSession = "There is no session on this object or a parent. Assign the session whose status is shown.";

        public const string PanelText =
            "It has no text to copy. Assign a child text, whose font, material, style and colour apply to the whole panel.";

        public const string Rig = "There is no rig on a parent. Move the object below a rig, or assign a rig.";
    }
}
