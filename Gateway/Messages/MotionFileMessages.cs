namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about recorded motions. The reader adds the file and the row.</summary>
static class MotionFileMessages
{
    public static string Session(string path) =>
        $"{path}: is a session; enter a motion, a .csv or .csv.gz file with the time and one column for each joint";

    public static string LineTooLong(string path, int line, int maxMebibytes) =>
        $"{path}:{line}: the line or a field is longer than {maxMebibytes} MiB; shorten it";

    public static string Quotation(string path, int row) => $"{path}:{row}: a quotation mark is inside a field; quote whole fields or none";
    public static string TooFewRows(string path, int rows) => $"{path}: has {(rows == 0 ? "no row" : "only one row")} of data; a motion needs at least 2";
    public static string Empty(string path) => $"{path}: is empty; a header such as t,joint_1,joint_2 is needed";

    public static string BodyHeader(string header, string expected) =>
        $"the header is {header}; the header of a rigid-body file must be exactly {expected}";

    public static string FirstColumn(string header) =>
        $"first column is {header}; the header must begin with t or t_s, the time in seconds, and its columns must be separated by commas";

    /// <param name="separator">Name of the character, for example "semicolons".</param>
    public static string OtherSeparator(string separator) =>
        $"the columns are separated by {separator}; separate them by commas, and use a point as the decimal separator";

    public static string NoJoint(string header) => $"no joint column after {header}; at least one is needed";
    public static string NoName(int column) => $"column {column} has no name; each joint needs one";
    public static string NameTwice(int column, string name) => $"column {column}: name {name} occurs twice; each joint needs its own name";
    public static string FieldCount(int fields, int header) => $"{fields} fields; the header has {header}; write one field for each column";

    public static string TimeOrder(string field, string value) =>
        $"field {field}: {value} s is not later than the time of the previous row; times must increase";

    public static string NormRange(string fields, double length, double min, double max) =>
        FormattableString.Invariant($"fields {fields}: the quaternion has length {length:G6}; allowed: {min:G6} to {max:G6}");

    public static string EmptyField(string field) => $"field {field} is empty; a number is needed";
    public static string NotANumber(string field, string text) => $"field {field}: {text} is not a number; {NumberRemedy(text.Contains(','))}";

    /// <summary>Gets the remedy for a text that is not a number.</summary>
    public static string NumberRemedy(bool hasComma) => hasComma ? "use a point as the decimal separator" : "correct it, or remove the row";

    public static string NotFinite(string field, string text) => $"field {field}: {text} is not a finite number; correct it, or remove the row";

    public static string TooLarge(string field, string text, double max) =>
        FormattableString.Invariant($"field {field}: {text} is too large; the maximum is {max:0e+0}");

    public const string NoFile = "no file is given; enter the path of a .csv or .csv.gz file";

    public static string IsAFolder(string path) => $"{path}: is a folder; enter the path of a .csv or .csv.gz file";
    public static string NotUtf8(string path, byte value) => $"{path}: is not UTF-8 text (byte {value:x2}); save it as UTF-8";
    public static string NotGzip(string path) => $"{path}: is not a complete gzip file, although its name ends in .gz; compress or copy it again";
}
