namespace UnityEditor;

public sealed class AssetDatabase
{
    public static string GUIDToAssetPath(string guid) => Project.PathOf(guid) ?? "";

    public static string GetAssetPath(Object assetObject) => Project.PathOf(assetObject) ?? "";

    public static Object[] LoadAllAssetsAtPath(string assetPath) => Project.Load(assetPath).ToArray();

    public static Object LoadMainAssetAtPath(string assetPath) => LoadAssetAtPath<Object>(assetPath);

    public static T LoadAssetAtPath<T>(string assetPath) where T : Object => Project.Load(assetPath).OfType<T>().FirstOrDefault();

    /// <param name="filter">Search filter. The stand-in supports only the form t:TYPE.</param>
    public static string[] FindAssets(string filter) => Project.OfType(filter.StartsWith("t:", StringComparison.Ordinal)
        ? filter.Substring(2)
        : throw new NotSupportedException("only t:TYPE is supported, not " + filter)).ToArray();
}
