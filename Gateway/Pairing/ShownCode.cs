using System.Security.Cryptography;
using Nowpose.Gateway.Security;
using Nowpose.Pairing;
using Nowpose.Protocol;
using Base64Url = System.Buffers.Text.Base64Url;

namespace Nowpose.Gateway.Pairing;

/// <summary>The code that a headset can exchange at present. Thread-safe.</summary>
/// <remarks>It is replaced when it is used, when it expires, and on request.</remarks>
sealed class ShownCode(CertificatePin pin, TimeProvider time)
{
    readonly object _gate = new();
    TokenCode _code;
    long _made;
    bool _isUsed = true;

    /// <summary>Gets the code to show, and the remaining time of its validity.</summary>
    public TokenCode Current(out TimeSpan left)
    {
        lock (_gate)
        {
            if (!IsValid) Make();
            left = PairingLimits.CodeValidity - time.GetElapsedTime(_made);
            return _code;
        }
    }

    /// <summary>Invalidates the shown code.</summary>
    public void Discard()
    {
        lock (_gate)
            _isUsed = true;
    }

    /// <summary>Exchanges the token of the shown code once. The code stays valid if <paramref name="give"/> fails.</summary>
    /// <returns>The result of the exchange; null for any other token.</returns>
    public string Take(string token, Func<string> give)
    {
        lock (_gate)
        {
            // Always compared, so that the time does not reveal whether there is a code.
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
