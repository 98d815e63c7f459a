namespace Nowpose.Editor.Messages
{
    /// <summary>Error messages about the meshes of a robot description, each with a remedy.</summary>
    static class MeshMessages
    {
        public const string Xacro = "is not a path; expand the file with xacro first";
        public const string Scheme = "is not supported; use package://, file:// or a path";
        public const string NoFileInPackage = "does not name a file in a package; use package://NAME/PATH";

        public static string NotFound(string mesh, string places) =>
            $"'{mesh}' was not found; searched at {places}; copy the file there or correct the path";

        public const string Outside = "is outside the project's Assets and Packages; copy it beside the URDF and use a path relative to the URDF";

        /// <param name="fault">Name of the mesh and the problem, with a remedy.</param>
        public static string Of(string fault) => $"mesh {fault}";

        public static string Format(string mesh) => $"mesh '{mesh}' has an unsupported format; allowed: STL, OBJ, DAE and FBX";
        public static string NotImported(string path) => $"mesh {path}: Unity has not imported it; see its import log for the reason";

        public static string UrdfTooLong(string file, long bytes, long max) =>
            $"{file}: {bytes} bytes; the maximum is {max}; check that it is a URDF";
    }
}
