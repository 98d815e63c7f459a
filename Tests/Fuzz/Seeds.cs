using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Fuzz;

/// <summary>Valid inputs for each kind of external data.</summary>
static class Seeds
{
    static readonly string[] Templates =
    [
        """{"op":"publish","topic":"/joint_states","msg":{"header":{"seq":3,"stamp":ROS1,"frame_id":""},"name":["arm_joint_1","arm_joint_2"],"position":[0.5,-1.25],"velocity":[0.1,null],"effort":[NaN,0]}}""",
        """{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":ROS2,"frame_id":"x"},"name":["a"],"position":[1e-3],"velocity":[],"acceleration":[-2]}}""",
        """{"op":"publish","topic":"/joint_trajectory","msg":{"header":{"stamp":ROS2},"joint_names":["a","b"],"points":[{"positions":[0,1],"velocities":[0.1,0.2],"accelerations":[],"time_from_start":{"sec":0,"nanosec":500000000}},{"positions":[1,2],"time_from_start":{"secs":1,"nsecs":0}}]}}""",
        """{"op":"publish","topic":"/robot_description","msg":{"data":"<robot name=\"r\"><link name=\"l\"/></robot>"}}""",
        """{"op":"publish","topic":"/nowpose/diagnostics","msg":{"header":{"stamp":ROS2},"status":[{"level":0,"name":"nowpose","message":"","hardware_id":"left","values":[{"key":"rtt_ms","value":"1.5"}]}]}}""",
        """{"op":"service_response","id":"nowpose time 7","service":"/rosapi/get_time","values":{"time":ROS1},"result":true}""",
        """{"op":"service_response","service":"/rosapi/get_time","values":"Service does not exist","result":false}""",
        """{"op":"service_response","service":"/rosapi/topics","values":{"topics":["/tf","/arm1/joint_states"],"types":["",""]},"result":true}""",
        """{"op":"service_response","id":"1","service":"/nowpose/plant_time/plc","result":true,"values":{"received":ROS2,"sent":ROS2,"resolution_ns":1000000,"error_bound_ns":0,"synchronised":true}}""",
        """{"op":"publish","topic":"/nowpose/joint_status","msg":{"header":{"stamp":ROS2},"status":[{"level":2,"name":"joints","message":"","hardware_id":"gateway","values":[{"key":"a1","value":"rest 1700000000.250 "},{"key":"a3","value":"fault 1700000000.250 node deleted"}]}]}}""",
        """{"op":"publish","topic":"/tf","msg":{"transforms":[{"header":{"seq":0,"stamp":ROS1,"frame_id":"world"},"child_frame_id":"belt","transform":{"translation":{"x":0.5,"y":-1e-3,"z":0},"rotation":{"x":0,"y":0,"z":0.6,"w":0.8}}},{"header":{"stamp":ROS2,"frame_id":"belt"},"child_frame_id":"box","transform":{"rotation":{"x":0,"y":0,"z":0,"w":-1.0005},"translation":{"x":0,"y":0,"z":1}}}]}}""",
        """{"op":"publish","topic":"/tf_static","msg":{"transforms":[{"header":{"stamp":{"sec":0,"nanosec":0},"frame_id":"arm1/tool0"},"child_frame_id":"fixture","transform":{"translation":{"x":0,"y":0,"z":0},"rotation":{"x":0,"y":0,"z":0,"w":1}}}]}}""",
        """{"op":"publish","topic":"/signals","msg":{"header":{"stamp":ROS2,"frame_id":""},"name":["grip","belt.speed"],"value":[1,-0.25]}}""",
        """{"op":"publish","topic":"/arm1/joint_states","msg":{"header":{"stamp":ROS2,"frame_id":""},"name":["a"],"position":[0.5]}}""",
        """{"op":"advertise_service","service":"/nowpose/plant_time/plc","type":"nowpose/PlantTime"}""",
        """{"op":"subscribe","id":"s1","topic":"/joint_states","type":"sensor_msgs/msg/JointState","throttle_rate":50,"queue_length":1,"compression":"none"}""",
        """{"op":"advertise","topic":"/joint_states","type":"sensor_msgs/JointState","latch":false,"queue_size":100}""",
        """{"op":"unsubscribe","topic":"/joint_states"}""",
        """{"op":"call_service","id":"c","service":"/rosapi/get_time","args":{}}""",
        """{"op":"status","level":"error","msg":"no"}""",
    ];

    public static readonly string[] Messages =
    [
        .. Templates.Select(text => text
            .Replace("ROS1", """{"secs":1700000000,"nsecs":250000000}""").Replace("ROS2", """{"sec":1700000000,"nanosec":250000000}""")),
    ];

    public static readonly string[] Configurations =
    [
        "# the gateway of hall 3\nbind: any\nsync-port: 47010\nws-port: 47011\ntls: true\ncertificate: /etc/nowpose/gateway.pfx\n"
        + "plant:\n  - /etc/nowpose/robot.yaml\n  - \"/etc/nowpose/plc 2.yaml\"\nmax-connections: 256\nskew-ppm: -12.5\ncell: 'Cell 3'\n",
        "{ bind: 127.0.0.1, plant: [a.yaml, b.yaml], record: true }\n",
    ];

    public static readonly string[] Tokens =
    [
        "# the cell's tokens\nobserver 4f5a6b7c8d9e\nsource 0123456789abcdef\n\noperator  s3cret-operator\n",
        "observer a\r\nsource b\r\n",
    ];

    public static readonly string[] Paired =
    [
        "observer sha256/47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU= 2026-03-01T12:00:00Z HoloLens left\n"
        + "# gone: \nobserver sha256/AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA= 2026-03-02T08:30:15Z two words\n",
    ];

    public static readonly string[] Codes =
    [
        new CellCode("Cell 3", "192.168.0.5", CertificatePin.Parse("sha256/47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="), null, 0.12, 47020, 47021).ToString(),
        new CellCode("a", "localhost", null, MarkerOffset.Parse("0.1,-0.25,0.5,0,90,-45", "offset")).ToString(),
    ];

    public static readonly string[] Robots =
    [
        """
        <?xml version="1.0"?>
        <robot name="r">
          <material name="grey"><color rgba="0.5 0.5 0.5 1"/></material>
          <link name="base"><visual><origin xyz="0 0 0.1" rpy="0 0 1.5708"/><geometry><box size="1 2 3"/></geometry><material name="grey"/></visual></link>
          <link name="arm"><visual><geometry><cylinder radius="0.1" length="0.5"/></geometry></visual></link>
          <link name="slide"><visual><geometry><mesh filename="package://r/a.stl" scale="1 1 1"/></geometry></visual></link>
          <link name="tool0"/>
          <joint name="j1" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0 0 1" rpy="0 0.1 0"/><axis xyz="0 0 1"/><limit lower="-3" upper="3" velocity="1.5" effort="10"/></joint>
          <joint name="j2" type="prismatic"><parent link="arm"/><child link="slide"/><axis xyz="1 0 0"/><limit lower="0" upper="0.3" velocity="0.5" effort="1"/></joint>
          <joint name="j3" type="fixed"><parent link="slide"/><child link="tool0"/></joint>
        </robot>
        """,
    ];

    public const string StationaryFrames = """
        {
          "transforms": [
            {
              "header": { "stamp": { "sec": 0, "nanosec": 0 }, "frame_id": "world" },
              "child_frame_id": "conveyor",
              "transform": {
                "translation": { "x": 0.5, "y": -0.001, "z": 0 },
                "rotation": { "x": 0, "y": 0, "z": 0.6, "w": 0.8 }
              }
            },
            {
              "header": { "stamp": { "sec": 0, "nanosec": 0 }, "frame_id": "conveyor" },
              "child_frame_id": "fixture",
              "transform": {
                "translation": { "x": 1e-3, "y": 2, "z": -0.25 },
                "rotation": { "x": 0, "y": 0, "z": 0, "w": -1.0005 }
              }
            }
          ]
        }

        """;

    public const string Body =
        "t_s,x,y,z,qx,qy,qz,qw\n0,0.5,-0.25,1,0,0,0,1\n0.01,0.501,-0.25,1,0,0,0.6,0.8\n0.02,5.02e-1,-0.25,1,0,0,-0.6,-0.8\n"
        + "\n1700000000.03, 0.503 ,-0.25,1,0.5,0.5,0.5,0.5\n";

    public static readonly string Profile = LatencyProfileJson.Write(new LatencyProfile(
        40.2, 1.1, "HoloLens 2", 60, new DateTime(2026, 3, 1, 0, 0, 0, DateTimeKind.Utc), CalibrationMethod.Sine, 300, 15, RenderTimeSourceKind.DisplayGpuTime, 15));
}
