using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public class RosTimeAnswerTests
{
    [Test]
    public void Problem_CallFailed_ReturnsOneLineWithASuggestion()
    {
        var said = "Service /rosapi/get_time\\r\\ndoes not exist" + new string('.', 1000);
        RosbridgeReader.TryRead($$"""{"op":"service_response","service":"/rosapi/get_time","values":"{{said}}","result":false}""", out var response, out var fault);

        var answer = new RosTimeAnswer(response, fault, HeadsetTime.FromSeconds(1));

        Assert.That(answer.Time, Is.Null);
        Assert.That(answer.Problem, Does.StartWith("Service /rosapi/get_time  does not exist").And.EndWith(ConnectionMessages.RosCallFailed("")));
        Assert.That(answer.Problem, Has.Length.LessThan(400));
    }

    [Test]
    public void Problem_RosbridgeHasLostItsCapsule_SuggestsARestart()
    {
        const string Said = "Object of type 'NoneType' is not an instance of 'capsule'";
        RosbridgeReader.TryRead(
            $$"""{"op":"service_response","service":"/rosapi/get_time","values":"{{Said}}","result":false}""", out var response, out var fault);

        var answer = new RosTimeAnswer(response, fault, HeadsetTime.FromSeconds(1));

        Assert.That(answer.Problem, Does.StartWith(Said).And.Contain("restart rosbridge").And.Not.Contain("rosapi"));
    }
}
