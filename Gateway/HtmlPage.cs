using System.Text;
using System.Text.RegularExpressions;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway;

/// <summary>A page from the folder Web, which may not have been built with the gateway.</summary>
/// <param name="html">Null if the page was not built.</param>
sealed partial class HtmlPage(string html)
{
    /// <summary>Message for a missing page.</summary>
    public const string Missing = OperationsMessages.PageMissing;

    readonly string _policy = PolicyOf(html);
    readonly byte[] _page = html == null ? null : Encoding.UTF8.GetBytes(html);

    public bool IsBuilt => _page != null;

    public Task SendAsync(HttpContext context)
    {
        if (!IsBuilt) return AccessControl.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, Missing);
        var response = context.Response;
        response.ContentType = "text/html; charset=utf-8";
        response.ContentLength = _page.Length;
        response.Headers.CacheControl = "no-store";
        // Closes the connection, because it needed no token and must not use a place of connections with a token.
        response.Headers.Connection = "close";
        response.Headers.ContentSecurityPolicy = _policy;
        return response.Body.WriteAsync(_page).AsTask();
    }

    // The page's own policy, which has the hashes of its script and style. Only a header can restrict framing: another site could make the
    // visitor click in the page, or could read it.
    static string PolicyOf(string html) => html == null ? null : $"{Policy().Match(html).Groups[1].Value}; frame-ancestors 'none'";

    [GeneratedRegex("http-equiv=\"Content-Security-Policy\"\\s+content=\"([^\"]*)\"")]
    private static partial Regex Policy();
}
