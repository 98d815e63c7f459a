using System.Globalization;
using Nowpose.Kinematics;

namespace Nowpose.Gateway.MotionRecordings;

/// <summary>Reads one motion recording row by row. Errors name the file and the line.</summary>
sealed class MotionRecordingReader : IDisposable
{
    const int MaxShownLength = 40;

    /// <summary>Maximum magnitude of a value. The difference of any two smaller values is finite.</summary>
    const double MaxMagnitude = 8e307;

    readonly string _path;
    readonly CsvRows _csv;
    readonly List<double> _times = [];
    readonly List<double> _positions = [];
    string[] _header;
    double _start;
    decimal? _exactStart;
    bool _isBody;

    public MotionRecordingReader(string path, TextReader text)
    {
        _path = path;
        _csv = new CsvRows(text, (line, field) =>
        {
            if (_header == null) RequireCommas(field);
            throw new InputException(MotionFileMessages.Quotation(path, line));
        });
    }

    public MotionRecording Read()
    {
        ReadHeader();
        while (_csv.Next()) ReadRow();
        if (_times.Count < 2) throw new InputException(MotionFileMessages.TooFewRows(_path, _times.Count));
        return new MotionRecording(_header[1..], _start, [.. _times], [.. _positions]) { IsBody = _isBody, Source = _path };
    }

    public void Dispose() => _csv.Dispose();

    void ReadHeader()
    {
        if (!_csv.Next()) throw new InputException(MotionFileMessages.Empty(_path));
        _header = _csv.Fields();
        _isBody = BodyColumns.Are(_header);
        if (!_isBody && BodyColumns.Resemble(_header))
            throw Wrong(MotionFileMessages.BodyHeader(Shown(string.Join(',', _header)), BodyColumns.Header));
        RequireCommas(_header[0]);
        if (_header[0] is not ("t" or "t_s"))
            throw Wrong(MotionFileMessages.FirstColumn(Shown(_header[0])));
        if (_header.Length < 2) throw Wrong(MotionFileMessages.NoJoint(_header[0]));
        for (var i = 1; i < _header.Length; i++) CheckName(i);
    }

    void RequireCommas(string firstField)
    {
        if (firstField.Contains(';')) throw Wrong(MotionFileMessages.OtherSeparator("semicolons"));
        if (firstField.Contains('\t')) throw Wrong(MotionFileMessages.OtherSeparator("tabs"));
    }

    void CheckName(int column)
    {
        var name = _header[column];
        if (name.Length == 0) throw Wrong(MotionFileMessages.NoName(column + 1));
        if (Array.IndexOf(_header, name) < column)
            throw Wrong(MotionFileMessages.NameTwice(column + 1, Shown(name)));
    }

    void ReadRow()
    {
        if (_csv.Count != _header.Length)
            throw Wrong(MotionFileMessages.FieldCount(_csv.Count, _header.Length));
        var time = Number(0);
        var exact = Exact(time);
        if (_times.Count == 0) (_start, _exactStart) = (time, exact);
        // Subtracts before rounding, because a double that holds seconds since 1970 has a resolution of only 0.24 µs.
        var elapsed = (double?)(exact - _exactStart) ?? time - _start;
        if (_times.Count > 0 && !(elapsed > _times[^1]))
            throw Wrong(MotionFileMessages.TimeOrder(_header[0], Shown(_csv[0])));
        _times.Add(elapsed);
        for (var i = 1; i < _header.Length; i++) _positions.Add(Number(i));
        if (_isBody) RequireUnit(System.Runtime.InteropServices.CollectionsMarshal.AsSpan(_positions)[^4..]);
    }

    void RequireUnit(ReadOnlySpan<double> quaternion)
    {
        if (UnitQuaternion.TryNormalise(quaternion[0], quaternion[1], quaternion[2], quaternion[3], out _)) return;
        var length = UnitQuaternion.LengthOf(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
        throw Wrong(MotionFileMessages.NormRange(BodyColumns.Quaternion, length, 1 - UnitQuaternion.LengthTolerance, 1 + UnitQuaternion.LengthTolerance));
    }

    /// <summary>Gets the exact time of the row; null if the type decimal cannot hold it.</summary>
    decimal? Exact(double rounded)
    {
        var isRead = decimal.TryParse(_csv[0], NumberStyles.Float, CultureInfo.InvariantCulture, out var value);
        // Compares with the rounded value, because a value too small for a decimal becomes 0 without an error.
        return isRead && Math.Abs((double)value - rounded) <= 1e-15 * Math.Abs(rounded) ? value : null;
    }

    double Number(int column)
    {
        var text = _csv[column];
        if (text.Length == 0) throw Wrong(MotionFileMessages.EmptyField(Shown(_header[column])));
        // Python and C write inf, which is not a number in .NET.
        var isInfinity = text.TrimStart('-', '+').Equals("inf", StringComparison.OrdinalIgnoreCase);
        if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var value) && !isInfinity)
            throw Wrong(MotionFileMessages.NotANumber(Shown(_header[column]), Shown(text)));
        if (isInfinity || !double.IsFinite(value)) throw Wrong(MotionFileMessages.NotFinite(Shown(_header[column]), Shown(text)));
        if (Math.Abs(value) > MaxMagnitude)
            throw Wrong(MotionFileMessages.TooLarge(Shown(_header[column]), Shown(text), MaxMagnitude));
        return value;
    }

    InputException Wrong(string what) => new($"{_path}:{_csv.Line}: {what}");

    /// <summary>Formats a value for a one-line message: short and without line breaks.</summary>
    static string Shown(string value)
    {
        var text = value.Length <= MaxShownLength ? value : value[..MaxShownLength] + "…";
        return "'" + string.Concat(text.Select(c => char.IsControl(c) ? ' ' : c)) + "'";
    }
}
