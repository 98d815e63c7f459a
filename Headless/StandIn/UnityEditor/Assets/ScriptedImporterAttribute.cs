namespace UnityEditor.AssetImporters;

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public class ScriptedImporterAttribute : Attribute
{
    public ScriptedImporterAttribute(int version, string ext, int importQueueOffset) => fileExtensions = new[] { ext };

    public string[] fileExtensions { get; }
}
