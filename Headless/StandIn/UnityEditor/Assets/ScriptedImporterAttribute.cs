using System;

namespace UnityEditor.AssetImporters;

[AttributeUsage(AttributeTargets.Class, Inherited = false)]
public class ScriptedImporterAttribute : Attribute
{
    public ScriptedImporterAttribute(int version, string ext) : this(version, ext, 0) { }

    public ScriptedImporterAttribute(int version, string ext, int importQueueOffset)
    {
        this.version = version;
        fileExtensions = new[] { ext };
        importQueuePriority = importQueueOffset;
    }

    public int version { get; }
    public string[] fileExtensions { get; }
    public int importQueuePriority { get; }
}
