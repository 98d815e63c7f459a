namespace UnityEditor;

public class AssetImporter : Object
{
}
