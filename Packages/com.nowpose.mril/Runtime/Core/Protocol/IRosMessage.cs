using System;
using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>The body of a publication.</summary>
    interface IRosMessage
    {
        /// <summary>Writes the message as one JSON object.</summary>
        /// <exception cref="ArgumentException">A number that must be finite is not.</exception>
        void Write(JsonWriter json, RosTimeForm form);
    }
}
