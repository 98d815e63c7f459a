using System;

namespace Nowpose.UnityPlayer.Assets;

/// <summary>
/// Thrown when an asset file is invalid, or when Unity would lose some of its data. The message names the file, the fileID of the object, and the
/// field.
/// </summary>
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

    public AssetException(AssetFault fault, string message, Exception innerException = null)
        : base(message, innerException) => Fault = fault;

    /// <summary>The kind of error.</summary>
    public AssetFault Fault { get; }
}
