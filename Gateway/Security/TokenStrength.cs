namespace Nowpose.Gateway.Security;

/// <summary>Estimates how hard a token is to guess: its length times the bits per character of its alphabet.</summary>
/// <remarks>
/// The alphabet is the smallest common one that contains all of the token's characters: digits, hexadecimal digits, or the sum of those
/// groups that occur: digits, lower-case letters, upper-case letters and other characters. Repeated characters count less.
/// </remarks>
static class TokenStrength
{
    /// <summary>Minimum strength, bits. A weaker token can be guessed.</summary>
    public const double MinBits = 128;

    const int Digits = 10, HexadecimalDigits = 16, MixedHexadecimalDigits = 22, Letters = 26, OtherCharacters = 32;

    /// <summary>Divisor of the expected minimum: a random token has at least half as many different characters as it can have.</summary>
    const int RepetitionShare = 2;

    public static double BitsOf(string token)
    {
        var alphabet = AlphabetOf(token);
        var distinct = token.Distinct().Count();
        // "aaaa…" is not a random choice among 26 letters.
        var possible = Math.Min(alphabet, token.Length);
        return token.Length * Math.Log2(distinct * RepetitionShare < possible ? distinct : alphabet);
    }

    static int AlphabetOf(string token)
    {
        if (token.All(char.IsAsciiDigit)) return Digits;
        if (token.All(c => char.IsAsciiHexDigitLower(c)) || token.All(c => char.IsAsciiHexDigitUpper(c))) return HexadecimalDigits;
        if (token.All(char.IsAsciiHexDigit)) return MixedHexadecimalDigits;
        return (token.Any(char.IsAsciiDigit) ? Digits : 0) + (token.Any(char.IsAsciiLetterLower) ? Letters : 0)
            + (token.Any(char.IsAsciiLetterUpper) ? Letters : 0) + (token.All(char.IsAsciiLetterOrDigit) ? 0 : OtherCharacters);
    }
}
