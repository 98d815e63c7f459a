using Newtonsoft.Json;

namespace Nowpose.Protocol
{
    /// <summary>std_msgs/String, for example with the robot description.</summary>
    sealed class StringMessage : IRosMessage
    {
        public StringMessage(string data) => Data = data;

        public string Data { get; }

        public void Write(JsonWriter json, RosTimeForm form)
        {
            json.WriteStartObject();
            json.Text("data", Data);
            json.WriteEndObject();
        }
    }
}
