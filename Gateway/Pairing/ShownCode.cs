using System.Security.Cryptography;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Nowpose.Protocol;
using Base64Url = System.Buffers.Text.Base64Url;

namespace Nowpose.Gateway.Pairing;

/// <summary>The one code that a headset may exchange at the moment. Any thread.</summary>
/// <remarks>Another one takes its place when it is used, when it is too old, and when somebody asks for one.</remarks>
sealed class ShownCode(CertificatePin pin, TimeProvider time)
{
    readonly object _gate = new();
    TokenCode _code;
    long _made;
    bool _isUsed = true;

    /// <summary>The code to show, and for how long it is still worth something.</summary>
    public TokenCode Current(out TimeSpan left)
    {
        lock (_gate)
        {
            if (!IsValid) Make();
            left = PairingLimits.CodeValidity - time.GetElapsedTime(_made);
            return _code;
        }
    }

    /// <summary>The code that is shown is worth nothing any more.</summary>
    public void Discard()
    {
        lock (_gate)
            _isUsed = true;
    }

    /// <summary>Exchanges the token of the shown code, once: it stays what it was when <paramref name="give"/> fails.</summary>
    /// <returns>What was given; null for any other token.</returns>
    public string Take(string token, Func<string> give)
    {
        lock (_gate)
        {
            // Compared all the same: whether there is a code at all does not show in the time.
            var isIt = CryptographicOperations.FixedTimeEquals(TokenList.HashOf(token ?? ""), TokenList.HashOf(_code?.Token ?? ""));
            if (!isIt || !IsValid) return null;
            var given = give();
            _isUsed = true;
            return given;
        }
    }

    bool IsValid => !_isUsed && time.GetElapsedTime(_made) < PairingLimits.CodeValidity;

    void Make()
    {
        _made = time.GetTimestamp();
        _isUsed = false;
        _code = new TokenCode(
            pin, Base64Url.EncodeToString(RandomNumberGenerator.GetBytes(TokenCode.TokenBytes)),
            time.GetUtcNow().UtcDateTime + PairingLimits.CodeValidity);
    }
}
