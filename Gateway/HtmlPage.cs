using System.Text;
using System.Text.RegularExpressions;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway;

/// <summary>A page from the folder Web. It may be missing, because a gateway can be built without Node.js.</summary>
/// <param name="html">The page; null if it was not built.</param>
sealed partial class HtmlPage(string html)
{
    readonly string _policy = PolicyOf(html);
    readonly byte[] _page = html == null ? null : Encoding.UTF8.GetBytes(html);

    public bool IsBuilt => _page != null;

    public Task SendAsync(HttpContext context)
    {
        if (!IsBuilt) return AccessControl.AnswerAsync(context, StatusCodes.Status503ServiceUnavailable, OperationsMessages.PageMissing);
        context.Response.Headers.ContentSecurityPolicy = _policy;
        return AccessControl.SendAsync(context, "text/html; charset=utf-8", _page);
    }

    // Copies the policy in the page, which contains the hashes of its script and style, into a header. Only a header can forbid other sites
    // to show the page in a frame, where they could make the visitor click in it.
    static string PolicyOf(string html) => html == null ? null : $"{Policy().Match(html).Groups[1].Value}; frame-ancestors 'none'";

    [GeneratedRegex("http-equiv=\"Content-Security-Policy\"\\s+content=\"([^\"]*)\"")]
    private static partial Regex Policy();
}
