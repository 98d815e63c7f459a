namespace Nowpose.Recording
{
    /// <summary>What a session file says of itself.</summary>
    static class SessionFormat
    {
        public const string Name = "nowpose-session";

        /// <summary>Grows only when a reader of the version before would misread a file; other lines and fields may be added without.</summary>
        public const int Version = 1;

        /// <summary>Version of the package that writes.</summary>
        public const string Package = "0.1.0";
    }
}
