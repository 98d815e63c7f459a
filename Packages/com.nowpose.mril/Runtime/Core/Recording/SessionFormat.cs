namespace Nowpose.Recording
{
    /// <summary>Name and versions in the header of a session file.</summary>
    static class SessionFormat
    {
        public const string Name = "nowpose-session";

        /// <summary>
        /// Format version. It is increased only if a reader of the previous version would misread a file, and not for new lines or fields.
        /// </summary>
        public const int Version = 1;

        /// <summary>Version of the package that writes the file.</summary>
        public const string Package = NowposeVersion.Text;
    }
}
