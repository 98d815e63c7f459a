namespace Nowpose.Gateway.Messages;

/// <summary>Errors in the file of tokens.</summary>
static class TokenFileMessages
{
    public const string Lines = "\"observer TOKEN\", \"source TOKEN\" or \"operator TOKEN\"";

    public static string NoToken(string path, string allowed) => $"{path}: contains no token; allowed: lines {allowed}";
    public static string NotALine(string where, string allowed) => $"{where}: the line must be {allowed}, the token without spaces";
    public static string TooLong(string where, int max) => $"{where}: the token is longer than {max} bytes; use a shorter one";
}
