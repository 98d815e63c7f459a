namespace Nowpose.Gateway;

/// <summary>
/// Adds headers to every response. They prevent browsers from guessing content types, and other sites from showing a page in a frame.
/// </summary>
static class SecurityHeaders
{
    /// <summary>Content security policy for responses that are not pages: a browser must not run or load anything from them.</summary>
    const string NoPage = "default-src 'none'; frame-ancestors 'none'";

    public static Task AddAsync(HttpContext context, RequestDelegate next)
    {
        var headers = context.Response.Headers;
        headers.XContentTypeOptions = "nosniff";
        headers["Referrer-Policy"] = "no-referrer";
        headers.XFrameOptions = "DENY";
        headers.ContentSecurityPolicy = NoPage;
        return next(context);
    }
}
