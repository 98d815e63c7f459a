namespace Nowpose.Messages
{
    /// <summary>Error messages about the list of paired cells.</summary>
    static class PairedCellMessages
    {
        public static string CodeCount(int codes, int max) => $"paired cell: {codes} codes; allowed: 1 to {max}";

        public const string SameCode = "paired cell: two codes are the same; remove one";
        public const string SeveralCells =
            "paired cell: the codes belong to several cells or gateways; all codes must belong to the same cell and gateway";

        public static string CellCount(int cells, int max) => $"paired cells: {cells} cells; allowed: up to {max}";

        public const string SameName = "paired cells: two cells have the same name; rename or remove one";
        public const string UsedNotInList = "paired cells: the cell in use must be in the list";
        public const string List = "list of paired cells";
        public const string NotComplete = "it must be a complete JSON object";

        public static string Unusable(string file, string reason) => $"{file}: cannot be used as a list of paired cells: {reason}";
        public static string Field(DropReason fault) => $"a field is missing, occurs twice, or has the wrong type ({fault})";
        public static string OtherFormat(string format) => $"its format must be '{format}'";
        public static string NewerVersion(long version, int max) => $"it has version {version}; this release of Nowpose reads version {max}; update Nowpose";

        public static string Unread(string reason) => $"{reason}; new cells are not saved; close the other program and restart the application";

        public static string Shared(string file, string other) =>
            $"{file} is also the file of the cell pairing of '{other}'; new cells are not saved; enter another File Name";

        /// <param name="copy">Path of the kept copy; null if there is none.</param>
        public static string Lost(string reason, string copy) => copy == null
            ? $"{reason}; look at the codes again"
            : $"{reason}; the file is kept as {copy}; look at the codes again";
    }
}
