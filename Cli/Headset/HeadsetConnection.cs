using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Cli.Headset;

/// <summary>Creates the connection settings of a run from the values of options.</summary>
static class HeadsetConnection
{
    const string Loopback = "127.0.0.1";

    /// <param name="pin">Value of <c>--pin</c>; null if it was not given.</param>
    /// <param name="tokenFile">Value of <c>--token-file</c>; null if it was not given.</param>
    /// <exception cref="InputException">A value is invalid. The message names the option.</exception>
    public static ConnectionSettings Of(
        string host, int syncPort, int webSocketPort, string pin, string tokenFile, bool insecureLan, string name)
    {
        var key = pin == null ? null : InputPlace.In("--pin", () => CertificatePin.Parse(pin));
        var token = tokenFile == null ? null : Token(tokenFile);
        InputPlace.In("--name", () => new ConnectionSettings(Loopback, headsetName: name));
        var isLoopback = InputPlace.In("--host", () => new ConnectionSettings(host, insecureLan: true)).IsLoopback;
        if (key == null && !isLoopback && token != null) throw new InputException(HeadsetMessages.TokenUnencrypted(host));
        if (key == null && !isLoopback && !insecureLan) throw new InputException(HeadsetMessages.PlainNotAllowed(host));
        return new ConnectionSettings(host, syncPort, webSocketPort, key, token: token, insecureLan: insecureLan, headsetName: name);
    }

    static string Token(string path)
    {
        var text = OptionPath.Read("--token-file", path, () => File.ReadAllText(path).Trim());
        return InputPlace.In($"--token-file: {path}", () => new ConnectionSettings(Loopback, token: text).Token);
    }
}
