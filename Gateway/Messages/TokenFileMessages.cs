namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about the token file.</summary>
static class TokenFileMessages
{
    const string Lines = "\"observer TOKEN\", \"source TOKEN\" or \"operator TOKEN\"";

    public static string NoToken(string path) => $"{path}: contains no token; allowed: lines {Lines}";
    public static string NotALine(string where) => $"{where}: the line must be {Lines}; the token must not contain spaces";
    public static string TwoRoles(string path, int first, int second) =>
        $"{path}: lines {first} and {second} give the same token different roles; remove one of the lines, or use another token in it";

    public static string TooLong(string where, int max) => $"{where}: the token is longer than {max} bytes; use a shorter one";
}
