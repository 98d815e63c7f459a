using Nowpose.Editor.Messages;
using UnityEditor;
using Object = UnityEngine.Object;

namespace Nowpose.Editor
{
    /// <summary>An asset of the package, identified by the GUID in its .meta file. Its path depends on how the package is installed.</summary>
    sealed class PackageAsset
    {
        PackageAsset(string name, string guid)
        {
            Name = name;
            Guid = guid;
        }

        public static PackageAsset RobotCell { get; } = new PackageAsset("Nowpose Robot Cell", "d0da6b2f3d4d30b3ea450fecec2534b3");
        public static PackageAsset RobotCellUr5 { get; } = new PackageAsset("Nowpose Robot Cell UR5", "e602b3296d36eb3d20de88f1ba6a7342");
        public static PackageAsset RobotCellAny { get; } = new PackageAsset("Nowpose " + SetupTexts.AnyRobotCell, "e8eea288bb4c4da5985170c59761926b");
        public static PackageAsset VirtualGripper { get; } = new PackageAsset("Virtual Gripper", "176885fd79569bed07f075035b658bde");
        public static PackageAsset Robot { get; } = new PackageAsset("Nowpose Robot", "4684d0cafe6b15f1d700d724137c2a91");
        public static PackageAsset PoseLabel { get; } = new PackageAsset("Pose Label", "20bf8de9cf3b1bce3e3caecc2074273d");
        public static PackageAsset Hologram { get; } = new PackageAsset("Hologram", "9de0e70208da3b674b333cda9ee663db");
        public static PackageAsset Ghost { get; } = new PackageAsset("Ghost", "553296ffa63da5f4788ce2846d03b3bc");
        public static PackageAsset Timestamp { get; } = new PackageAsset("Timestamp", "aa83367800e25fa19364e7d18432dcc5");
        public static PackageAsset HologramShader { get; } = new PackageAsset("Hologram", "a80c51a6e93c28d02a1283edfb854dcd");
        public static PackageAsset DefaultSettings { get; } = new PackageAsset("Default Session Settings", "66b6686ca18f5802cb9aa8d01ead1a10");

        public string Name { get; }
        public string Guid { get; }

        /// <summary>Path of the asset; empty if the project does not contain it.</summary>
        public string Path => AssetDatabase.GUIDToAssetPath(Guid);

        /// <summary>Loads the asset; returns null if the project does not contain it.</summary>
        public T Load<T>() where T : Object => AssetDatabase.LoadAssetAtPath<T>(Path);
    }
}
