using System.Text.Json;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Recording;

namespace Nowpose.Cli.SessionFiles;

/// <summary>Reads a session file line by line, so that the size of the file is not limited.</summary>
sealed class SessionFileReader : IDisposable
{
    readonly string _path;
    readonly TextReader _text;

    /// <exception cref="InputException">The file cannot be read, is not a session file, or has a newer version than this program.</exception>
    public SessionFileReader(string path)
    {
        _path = path;
        _text = RecordingText.Open(path);
        try
        {
            Header = ReadHeader();
        }
        catch
        {
            Dispose();
            throw;
        }
    }

    public SessionHeader Header { get; }

    /// <summary>Number of the last line that was read.</summary>
    public int Line { get; private set; }

    /// <summary>Reads the lines below the header. Skips lines of unknown kinds.</summary>
    /// <exception cref="InputException">
    /// A line has another format, or is the header of another session. The message names file, line and field.
    /// </exception>
    public IEnumerable<SessionLine> Lines()
    {
        while (ReadLine() is string text)
        {
            if (string.IsNullOrWhiteSpace(text)) continue;
            var line = Parse(text, out var isTorn);
            // The recording process ended while it was writing this line. All earlier lines are complete.
            if (isTorn) yield break;
            if (line != null) yield return line;
        }
    }

    public void Dispose() => _text.Dispose();

    SessionLine Parse(string text, out bool isTorn)
    {
        isTorn = false;
        try
        {
            using var json = JsonDocument.Parse(text);
            return SessionLines.Read(Fields(json));
        }
        catch (JsonException broken)
        {
            isTorn = IsLast();
            return isTorn ? null : throw new InputException(SessionFileMessages.NotJson(Place, OneLine(broken)), broken);
        }
    }

    SessionHeader ReadHeader()
    {
        var text = ReadLine() ?? throw new InputException(SessionFileMessages.Empty(_path));
        try
        {
            using var json = JsonDocument.Parse(text);
            var fields = Fields(json);
            if (fields.TextOrNull("format") != SessionFormat.Name)
                throw new InputException(SessionFileMessages.OtherFormat(Place, SessionFormat.Name));
            var version = fields.Whole("version");
            if (version is < 1 or > SessionFormat.Version)
                throw new InputException(SessionFileMessages.NewerVersion(Place, version, SessionFormat.Version));
            return SessionLines.ReadHeader(fields);
        }
        catch (JsonException broken)
        {
            throw new InputException(SessionFileMessages.NotJson(Place, OneLine(broken)), broken);
        }
    }

    string Place => $"{_path}:{Line}";

    LineFields Fields(JsonDocument json) => json.RootElement.ValueKind == JsonValueKind.Object
        ? new LineFields(Place, json.RootElement) : throw new InputException(SessionFileMessages.LineNotAnObject(Place));

    string ReadLine() => Guarded(() =>
    {
        Line++;
        return _text.ReadLine();
    });

    bool IsLast() => Guarded(_text.Peek) < 0;

    T Guarded<T>(Func<T> read)
    {
        try
        {
            return read();
        }
        catch (Exception e) when (RecordingText.IsUnreadable(e))
        {
            throw RecordingText.Unreadable(_path, e);
        }
    }

    // The library counts lines from 0 within this line of the file, which contradicts the line number of the file.
    static string OneLine(JsonException broken) =>
        broken.Message.Split(" LineNumber:")[0].ReplaceLineEndings(" ").TrimEnd('.') + SessionFileMessages.AtByte(broken.BytePositionInLine + 1);
}
