namespace Nowpose.Editor
{
    /// <summary>A prefab of the package, by the GUID in its .meta: its path differs between an embedded and an installed package.</summary>
    sealed class PackagePrefab
    {
        public static readonly PackagePrefab RobotCell = new PackagePrefab("Nowpose Robot Cell", "d0da6b2f3d4d30b3ea450fecec2534b3");
        public static readonly PackagePrefab RobotCellUr5 = new PackagePrefab("Nowpose Robot Cell UR5", "e602b3296d36eb3d20de88f1ba6a7342");
        public static readonly PackagePrefab VirtualGripper = new PackagePrefab("Virtual Gripper", "176885fd79569bed07f075035b658bde");

        PackagePrefab(string name, string guid)
        {
            Name = name;
            Guid = guid;
        }

        public string Name { get; }
        public string Guid { get; }
    }
}
