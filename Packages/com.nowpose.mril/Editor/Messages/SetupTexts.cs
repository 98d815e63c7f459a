namespace Nowpose.Editor.Messages
{
    /// <summary>Text of the set-up window and of the menu, and error messages of their actions.</summary>
    static class SetupTexts
    {
        public static string PrefabMissing(string prefab, string guid) =>
            $"The prefab '{prefab}' (GUID {guid}) is not in this project; reinstall the package com.nowpose.mril.";

        public static string PackageNotAdded(string package, string reason) => $"{package} could not be added: {reason}";

        public static string ManifestChanged(string file, string changes, string backup) =>
            $"{file} was changed: {changes}. The earlier file is {backup}.";

        /// <summary>Name of the menu entry for the cell without a robot.</summary>
        public const string AnyRobotCell = "Robot Cell (Any Robot)";

        public const string AndroidHeadset = "Android headset (Quest, Magic Leap 2)";
        public const string WindowTitle = "Nowpose Setup";
        public const string CheckAgain = "Check again";
        public const string AddToScene = "Add a cell to the scene, or a part below the selected object";

        public static string Adding(string package) => $"adding {package} …";

        /// <param name="missing">Number of missing items.</param>
        public static string Summary(int missing, string headset)
        {
            if (missing == 0) return $"Nothing is missing for {headset}.";
            return missing == 1 ? $"1 item is missing for {headset}." : $"{missing} items are missing for {headset}.";
        }
    }
}
