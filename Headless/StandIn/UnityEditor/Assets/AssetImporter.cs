using Object = UnityEngine.Object;

namespace UnityEditor;

public class AssetImporter : Object
{
    public string assetPath { get; internal set; }
}
