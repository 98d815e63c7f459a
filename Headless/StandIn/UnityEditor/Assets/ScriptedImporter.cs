namespace UnityEditor.AssetImporters;

public abstract class ScriptedImporter : AssetImporter
{
    protected ScriptedImporter() { }

    public abstract void OnImportAsset(AssetImportContext ctx);
}

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public class ScriptedImporterAttribute : Attribute
{
    public ScriptedImporterAttribute(int version, string ext, int importQueueOffset) => fileExtensions = new[] { ext };

    public string[] fileExtensions { get; }
}
