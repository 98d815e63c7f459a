using System;
using System.Globalization;

namespace Nowpose.Tests.Core
{
    /// <summary>
    /// Sets a culture with a decimal comma and a minus sign that is not a hyphen, as in Sweden; disposing the object restores the previous culture.
    /// </summary>
    sealed class DecimalComma : IDisposable
    {
        readonly CultureInfo _before = CultureInfo.CurrentCulture;

        public DecimalComma()
        {
            var comma = (CultureInfo)CultureInfo.InvariantCulture.Clone();
            (comma.NumberFormat.NumberDecimalSeparator, comma.NumberFormat.NumberGroupSeparator) = (",", ".");
            comma.NumberFormat.NegativeSign = "\u2212";
            CultureInfo.CurrentCulture = comma;
        }

        public void Dispose() => CultureInfo.CurrentCulture = _before;
    }
}
