using System.Globalization;
using System.Security.Cryptography;

namespace Nowpose.Gateway.Pairing;

/// <summary>One line of the list of paired headsets: the headset's name, the time of its pairing, and the hash of its token.</summary>
sealed record PairedHeadset(string Name, DateTime PairedUtc, byte[] Hash)
{
    public const int MaxNameLength = 64;

    const string Role = "observer", HashPrefix = "sha256/", TimeFormat = "yyyy-MM-dd'T'HH:mm:ss'Z'";

    /// <summary>Parses a line. Returns null if it is invalid.</summary>
    public static PairedHeadset Read(string line)
    {
        var words = line.Split(' ', 4);
        var hash = new byte[SHA256.HashSizeInBytes + 1];
        return words.Length == 4 && words[0] == Role && words[1].StartsWith(HashPrefix, StringComparison.Ordinal)
            && Convert.TryFromBase64String(words[1][HashPrefix.Length..], hash, out var length) && length == SHA256.HashSizeInBytes
            && DateTime.TryParseExact(
                words[2], TimeFormat, CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal | DateTimeStyles.AdjustToUniversal, out var paired)
            ? new PairedHeadset(words[3], paired, hash[..length]) : null;
    }

    /// <summary>Makes a headset's name safe for a line of the file: removes invisible characters and limits the length.</summary>
    public static string NameOf(string name)
    {
        var plain = new string([.. (name ?? "").Where(IsPlain)]).Trim();
        return plain.Length switch { 0 => "headset", > MaxNameLength => plain[..MaxNameLength].TrimEnd(), _ => plain };
    }

    static bool IsPlain(char c) => CharUnicodeInfo.GetUnicodeCategory(c) is not (
        UnicodeCategory.Control or UnicodeCategory.Format or UnicodeCategory.LineSeparator or UnicodeCategory.ParagraphSeparator
        or UnicodeCategory.Surrogate or UnicodeCategory.PrivateUse or UnicodeCategory.OtherNotAssigned);

    public override string ToString() =>
        $"{Role} {HashPrefix}{Convert.ToBase64String(Hash)} {PairedUtc.ToString(TimeFormat, CultureInfo.InvariantCulture)} {Name}";
}
