namespace Nowpose.Editor.Messages
{
    /// <summary>Error messages about Packages/manifest.json, each with a remedy.</summary>
    static class ManifestMessages
    {
        public const string AfterObject = "text follows the object; remove it";
        public static string Expected(char character) => $"{character} is expected";
        public static string Twice(string name) => $"\"{name}\" occurs twice";
        public static string Conflicts(string conflicts) => $"{conflicts}. Correct the manifest.";

        public static string NotAContainer(string place, string name, bool isObject) =>
            $"{place}: {name} must be {(isObject ? "an object" : "an array")}; correct it";

        public const string NoValue = "a value is expected";

        public static string TooDeep(string max) => $"nested more than {max} levels deep";

        public const string NoName = "a name in double quotes is expected";
        public const string StringEnd = "the string does not end, or has a character that must be escaped";

        public static string ReadOnly(string file) =>
            $"{file}: the file is read-only; make it writable, or check it out of version control, and try again";

        public static string TooLong(string file, string bytes) =>
            $"{file}: the file has {bytes} bytes; the limit is 1 MiB; remove what does not belong in a manifest";
        public static string ChangedMeanwhile(string file) => $"{file}: another program has changed the file; try again";

        public static string NotWritten(string file, string reason, string backup) =>
            $"{file}: not written completely ({reason}); copy {backup} over it, and try again";

        public static string NotUtf8(string file) => $"{file}: the file is not UTF-8; save it as UTF-8";

        public static string OtherVersion(string place, string package, string version, string needed) =>
            $"{place}: {package} is {version}; {needed} is needed";

        public static string VersionUnreadable(string package, string version, string needed) =>
            $"{package} is kept at {version}, which does not state a version; {needed} is needed; check that it has this version";

        public static string Scopes(string place) => $"{place}: scopes must be an array; correct it";
        public static string NotAString(string place, string name) => $"{place}: {name} must be a string: a version or an address; correct it";

        public static string NotJson(string file, string line, string reason, bool isComment) => isComment
            ? $"{file}:{line}: not a JSON object: {reason}; remove the comment, because JSON has none"
            : $"{file}:{line}: not a JSON object: {reason}; correct the line";

        /// <param name="url">Address of the registry in use; null if the registry has none.</param>
        /// <param name="isShared">Whether the registry in use also has other scopes.</param>
        public static string OtherRegistry(string place, string package, string url, string needed, bool isShared)
        {
            if (url == null) return $"{place}: {package} comes from a registry without url; {needed} is needed; add this url";
            return isShared
                ? $"{place}: {package} comes from the registry {url}; {needed} is needed; the registry also has other scopes; move "
                + "the package's scope to a registry with the needed url"
                : $"{place}: {package} comes from the registry {url}; {needed} is needed; change the url";
        }
    }
}
