using Object = UnityEngine.Object;

namespace UnityEditor;

public class AssetImporter : Object
{
}
