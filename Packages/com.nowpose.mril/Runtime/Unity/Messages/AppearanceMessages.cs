namespace Nowpose.Unity.Messages
{
    /// <summary>Messages about parts whose material cannot mark a pose as not current. The messages state a remedy.</summary>
    static class AppearanceMessages
    {
        public const string AssignMaterial = "assign a material to the part";
        public const string ChangeShader = "add NowposePose.hlsl to the shader; the manual's page Pose Appearance has an example";

        public static string NoMaterial(string part) => $"a material of '{part}' is missing";

        public static string NotFadeable(string material, string part) =>
            $"material '{material}' of '{part}' cannot show that the pose is not current: its shader lacks _Hatch or _Fade, and it is opaque, "
            + "is not blended by its alpha, or is one of several materials";

        public static string Substituted(string component, string problem, string substitute, string remedy) =>
            $"pose appearance '{component}': {problem}. While the pose is not current, the part is drawn with '{substitute}'. "
            + $"To keep its own look, {remedy}";

        public static string Hidden(string component, string problem, string remedy) =>
            $"pose appearance '{component}': {problem}. While the pose is not current, the part is hidden. "
            + $"Assign a Substitute with _Fade and _Hatch, or {remedy}";
    }
}
