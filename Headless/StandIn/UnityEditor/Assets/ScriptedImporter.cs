namespace UnityEditor.AssetImporters;

public abstract class ScriptedImporter : AssetImporter
{
    protected ScriptedImporter() { }

    public abstract void OnImportAsset(AssetImportContext ctx);
}
