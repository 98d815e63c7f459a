namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>A prefab inserted into another file. Unity computes the fileIDs of its objects from those of instance and prefab object.</summary>
sealed class PrefabInstance
{
    /// <summary>Class of the document with the parent and the changes of an instance.</summary>
    public const int ClassId = 1001;

    /// <summary>FileID of the prefab as a whole in references to it.</summary>
    public const long PrefabFileId = 100100000;

    public PrefabInstance(string file, long fileId, string sourceGuid, ObjectFile source)
    {
        File = file;
        FileId = fileId;
        SourceGuid = sourceGuid;
        Source = source;
    }

    /// <summary>The file that contains the instance.</summary>
    public string File { get; }

    public long FileId { get; }
    public string SourceGuid { get; }
    public ObjectFile Source { get; }

    /// <summary>Gets the fileID of a prefab's object in this file. 0 (no object) stays 0.</summary>
    public long Map(long sourceFileId) => sourceFileId == 0 ? 0 : (FileId ^ sourceFileId) & long.MaxValue;
}
