using System;

namespace Nowpose.UnityPlayer.Assets;

/// <summary>A file that Unity would misread, or read with something lost: says which file, which object of it (fileID) and which field.</summary>
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
