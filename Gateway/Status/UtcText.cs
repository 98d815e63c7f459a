using System.Globalization;

namespace Nowpose.Gateway.Status;

/// <summary>Formats and parses times for users and programs: UTC to the millisecond.</summary>
static class UtcText
{
    public static string Of(DateTimeOffset time) => time.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss.fff'Z'", CultureInfo.InvariantCulture);

    public static double UnixSeconds(string utc) => DateTimeOffset.Parse(utc, CultureInfo.InvariantCulture).ToUnixTimeMilliseconds() / 1000.0;
}
