using System.IO.Compression;

namespace Nowpose.Tests.Common;

/// <summary>A temporary file of a test, deleted when disposed.</summary>
sealed class TemporaryFile : IDisposable
{
    public TemporaryFile(string content, string ending = ".csv")
    {
        Path = System.IO.Path.Combine(System.IO.Path.GetTempPath(), "nowpose-" + Guid.NewGuid().ToString("N") + ending);
        using var bytes = File.Create(Path);
        using var stream = ending.EndsWith(".gz", StringComparison.Ordinal) ? new GZipStream(bytes, CompressionMode.Compress) : (Stream)bytes;
        using var writer = new StreamWriter(stream);
        writer.Write(content);
    }

    public string Path { get; }

    public void Dispose() => File.Delete(Path);
}
