namespace Nowpose.UnityPlayer.Assets.Prefabs;

/// <summary>A prefab put into another file: its objects get fileIDs there that Unity computes from the two.</summary>
sealed class PrefabInstance
{
    /// <summary>Class of the document that says where the instance hangs and what is changed in it.</summary>
    public const int ClassId = 1001;

    /// <summary>What stands for the prefab as a whole in references to it.</summary>
    public const long PrefabFileId = 100100000;

    public PrefabInstance(string file, long fileId, string sourceGuid, ObjectFile source)
    {
        File = file;
        FileId = fileId;
        SourceGuid = sourceGuid;
        Source = source;
    }

    /// <summary>The file that it is put into.</summary>
    public string File { get; }

    public long FileId { get; }
    public string SourceGuid { get; }
    public ObjectFile Source { get; }

    /// <summary>The fileID that an object of the prefab has in this file. 0 (no object) stays 0.</summary>
    public long Map(long sourceFileId) => sourceFileId == 0 ? 0 : (FileId ^ sourceFileId) & long.MaxValue;
}
