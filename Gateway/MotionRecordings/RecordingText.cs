using System.IO.Compression;
using System.Text;
using CsvHelper;
using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.MotionRecordings;

/// <summary>Opens text files that users name, plain or compressed with gzip.</summary>
public static class RecordingText
{
    /// <summary>
    /// Maximum length of a line. The longest lines are those of recorded sessions that contain a robot description, of at most 1 MiB without escapes.
    /// A longer line, which a small compressed file can contain, would only exhaust the memory.
    /// </summary>
    internal const int MaxLineMebibytes = 8;

    /// <summary>Gets whether a path has the name of a recorded session, which is not a motion.</summary>
    public static bool IsSession(string path) => path != null
        && (path.EndsWith(".jsonl", StringComparison.OrdinalIgnoreCase) || path.EndsWith(".jsonl.gz", StringComparison.OrdinalIgnoreCase));

    /// <summary>Opens a text file, and unpacks it while it is read if its name ends in <c>.gz</c>. The caller disposes the reader.</summary>
    /// <exception cref="InputException">The file does not exist or cannot be opened.</exception>
    public static TextReader Open(string path)
    {
        if (string.IsNullOrWhiteSpace(path))
            throw new InputException(MotionFileMessages.NoFile);
        if (Directory.Exists(path))
            throw new InputException(MotionFileMessages.IsAFolder(path));
        var bytes = FileFault.Report<Stream>(
            // Windows would otherwise refuse a file that another program is writing.
            () => new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete),
            e => FileFault.IsMissing(e) ? PathMessages.NotFound(path) : PathMessages.NotRead(path, e));
        var text = path.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? new GZipStream(bytes, CompressionMode.Decompress) : bytes;
        var lines = new LineLimitStream(
            text, line => throw new InputException(MotionFileMessages.LineTooLong(path, line, MaxLineMebibytes)), MaxLineMebibytes << 20);
        // Without an exception, the names of joints would contain other characters than those of the file. The identifier is the byte order mark: the
        // reader replaces an encoding without it after such a mark.
        return new StreamReader(lines, new UTF8Encoding(encoderShouldEmitUTF8Identifier: true, throwOnInvalidBytes: true));
    }

    /// <summary>Opens a text file as <see cref="Open"/> does, and reads it with a function.</summary>
    /// <exception cref="InputException">The file does not exist, or cannot be opened or read.</exception>
    public static T Read<T>(string path, Func<TextReader, T> read)
    {
        using var text = Open(path);
        try
        {
            return read(text);
        }
        catch (MaxFieldSizeException e)
        {
            throw new InputException(MotionFileMessages.LineTooLong(path, e.Context.Parser.RawRow, MaxLineMebibytes), e);
        }
        catch (Exception e) when (IsUnreadable(e))
        {
            throw Unreadable(path, e);
        }
    }

    /// <summary>Whether an exception is a failure while a file is being read.</summary>
    internal static bool IsUnreadable(Exception e) => e is IOException or InvalidDataException or DecoderFallbackException;

    /// <summary>Creates the exception for a failure while a file is being read.</summary>
    internal static InputException Unreadable(string path, Exception e) => new(e switch
    {
        InvalidDataException => MotionFileMessages.NotGzip(path),
        DecoderFallbackException other => MotionFileMessages.NotUtf8(path, other.BytesUnknown[0]),
        _ => PathMessages.NotRead(path, e),
    }, e);
}
