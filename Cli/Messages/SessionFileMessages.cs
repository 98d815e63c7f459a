namespace Nowpose.Cli.Messages;

/// <summary>Error messages about recorded sessions. The reader adds the file and the line.</summary>
static class SessionFileMessages
{
    public const string NotAString = "must be a string of valid Unicode";
    public const string NotASwitch = "must be true or false";

    public static string NotWhole(string value) => $"is {value}; it must be a whole number (64 bits)";
    public static string NotFinite(string value) => $"is {value}; it must be a finite number";
    public static string Count(int count, int? expected) => $"has {count} numbers; it must have {expected}";
    public static string ElementNotFinite(int element, string value) => $"has {value} as element {element}; it must be a finite number";
    public static string ElementNotAString(int element, string value) => $"has {value} as element {element}; it must be a string of valid Unicode";

    public const string NotAnObject = "must be an object";

    public static string ValueNotAnObject(string value) => $"is {value}; it must be an object";

    public const string NotAnArray = "must be an array";

    public static string NotJson(string place, string reason) =>
        $"{place}: is not a JSON object; record the session again, or remove the line: {reason}";

    /// <param name="position">Place in the line, from 1; null if unknown.</param>
    public static string AtByte(long? position) => position == null ? "" : FormattableString.Invariant($", at byte {position}");

    public static string Empty(string path) => $"{path}: is empty; the first line of a session file must be its header";

    public static string OtherFormat(string place, string format) =>
        $"{place}: field 'format' is not '{format}'; the first line of a session file must contain it";

    public static string NewerVersion(string place, long version, int supported) =>
        $"{place}: field 'version': the file has version {version}; this program reads version {supported}; update this program";

    public static string LinesLost(long lines) =>
        $"{lines} lines are missing, because the recording was slower than the session; record to a faster disk";

    public static string NoEnd(ControlTime end) =>
        "the session has no end line: it was copied while it was recorded, or the program crashed; the results are those up to the control time "
        + FormattableString.Invariant($"t = {(decimal)end.SinceEpoch.Ticks / TimeSpan.TicksPerSecond:0.000} s");

    public static string SecondHeader(string place) => $"{place}: another session begins here, but a file must contain only one; split it before this line";

    public static string LineNotAnObject(string place) => $"{place}: is not a JSON object; record the session again";
    public static string LimitOrder(double lower, double upper) =>
        FormattableString.Invariant($"is {lower}; it must not exceed the upper limit {upper}");
    public static string Nanoseconds(long value, long max) => FormattableString.Invariant($"is {value} ns; it must be from 0 to {max} ns");
    public const string Missing = "is missing; add it, or record the session again";
    public static string JointTwice(string joint) => $"has joint '{joint}' twice; remove one";
    public static string Limit(double value) => FormattableString.Invariant($"is {value}; a limit must be more than 0");
    public static string PointOrder(int point) =>
        $"of point {point} is negative, or not later than that of the previous point; times must increase";

    public static string TooFar(double value, double limit) =>
        FormattableString.Invariant($"has {value} m; allowed: {-limit:0} to {limit:0} m");

    /// <param name="longest">Maximum number of characters.</param>
    public static string Name(string value, int longest) => $"is '{InputException.OneLine(value, 32)}'; allowed: 1 to {longest} characters";

    public const string OwnParent = "is the frame itself; a frame must have another parent";
    public const string WorldAsFrame = "is world, the root of all frames, which has no pose; rename the frame";
    public const string NotARotation = "is not a rotation; it must be a unit quaternion x, y, z, w";
}
