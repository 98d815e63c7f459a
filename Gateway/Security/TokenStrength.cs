namespace Nowpose.Gateway.Security;

/// <summary>Estimates the strength of a token in bits: its length times the bits per character of its alphabet.</summary>
/// <remarks>
/// The alphabet is digits or hexadecimal digits, if the token contains no other characters. Otherwise it consists of the groups that occur in
/// the token: digits, lower-case letters, upper-case letters, other characters. A token with many repetitions has a smaller alphabet.
/// </remarks>
static class TokenStrength
{
    /// <summary>Minimum strength in bits. A weaker token can be guessed.</summary>
    public const double MinBits = 128;

    const int Digits = 10, HexadecimalDigits = 16, MixedHexadecimalDigits = 22, Letters = 26, OtherCharacters = 32;

    /// <summary>
    /// A token has many repetitions if its number of different characters is less than the number possible for its length and alphabet, divided by
    /// this constant.
    /// </summary>
    const int RepetitionShare = 2;

    public static double BitsOf(string token)
    {
        var alphabet = AlphabetOf(token);
        var distinct = token.Distinct().Count();
        // With too few different characters, as in "aaaa…", counts only these characters as the alphabet.
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
