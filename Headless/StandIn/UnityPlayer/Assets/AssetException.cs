using System;

namespace Nowpose.UnityPlayer.Assets;

/// <summary>A file is invalid, or Unity would lose data of it. The message names the file, the object (fileID) and the field.</summary>
public sealed class AssetException : Exception
{
    public AssetException()
    {
    }

    public AssetException(string message)
        : base(message)
    {
    }

    public AssetException(string message, Exception innerException)
        : base(message, innerException)
    {
    }
}
